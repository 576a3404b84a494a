# The libraries of Debian 12 that volsurf stands on. ITK and VTK are asked for by component: all of ITK would bring a
# second HDF5.
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo-png cairo-svg)
if(VOLSURF_WITH_CGAL)
  # CGAL 5.5 is headers only; what they need is in these two.
  pkg_check_modules(GMP REQUIRED IMPORTED_TARGET gmp)
  pkg_check_modules(MPFR REQUIRED IMPORTED_TARGET mpfr)
endif()
find_package(
  VTK 9.1 REQUIRED
  COMPONENTS CommonCore CommonDataModel FiltersCore IOGeometry IOPLY IOXML)
find_package(
  ITK 5.2 REQUIRED
  COMPONENTS ITKCommon ITKIOImageBase ITKIONRRD ITKIOMeta ITKIONIFTI ITKIOGDCM ITKImageGrid ITKSmoothing
             ITKThresholding ITKWatersheds)

# OpenVDB's own folder holds a FindTBB that would shadow TBB's configuration, so it is on the path only here.
set(VOLSURF_OPENVDB_MODULES /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
list(PREPEND CMAKE_MODULE_PATH ${VOLSURF_OPENVDB_MODULES})
find_package(OpenVDB 10 REQUIRED COMPONENTS openvdb)
list(REMOVE_ITEM CMAKE_MODULE_PATH ${VOLSURF_OPENVDB_MODULES})

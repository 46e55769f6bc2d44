# Third-party packages, as Debian 12 ships them. OpenImageIO, OSMesa and assimp come through
# pkg-config because their CMake packages are missing or broken there (that of assimp wants the
# development files of draco and minizip, which nothing here needs).
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL)
find_package(glm 0.9.9 CONFIG REQUIRED)
find_package(glfw3 3.3 CONFIG REQUIRED)
find_package(TBB CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(Eigen3 3.4 CONFIG REQUIRED)
pkg_check_modules(OSMESA REQUIRED IMPORTED_TARGET osmesa)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO>=2.4)
pkg_check_modules(HARFBUZZ REQUIRED IMPORTED_TARGET harfbuzz>=4)
pkg_check_modules(LIB2GEOM REQUIRED IMPORTED_TARGET 2geom)
pkg_check_modules(PUGIXML REQUIRED IMPORTED_TARGET pugixml)
pkg_check_modules(POLYCLIPPING REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp>=5)
if(RELIEVO_BUILD_TESTS)
  find_package(GTest CONFIG REQUIRED)
endif()

# OpenCV is optional: relievo-bench compares its distance transform with ours when it is there. Its
# CMake package comes with libopencv-dev alone, which pulls hundreds of others: its headers and two
# libraries are found without it.
find_path(RELIEVO_OPENCV_INCLUDE_DIR opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
find_library(RELIEVO_OPENCV_CORE opencv_core)
find_library(RELIEVO_OPENCV_IMGPROC opencv_imgproc)
mark_as_advanced(RELIEVO_OPENCV_INCLUDE_DIR RELIEVO_OPENCV_CORE RELIEVO_OPENCV_IMGPROC)
if(RELIEVO_OPENCV_INCLUDE_DIR AND RELIEVO_OPENCV_CORE AND RELIEVO_OPENCV_IMGPROC)
  add_library(relievo_opencv INTERFACE IMPORTED)
  set_target_properties(relievo_opencv PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${RELIEVO_OPENCV_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${RELIEVO_OPENCV_IMGPROC};${RELIEVO_OPENCV_CORE}")
endif()

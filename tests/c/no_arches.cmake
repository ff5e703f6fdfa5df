# cmake -DFOLDER=F -P no_arches.cmake: the folder, empty.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

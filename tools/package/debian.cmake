# Run by cpack between installing and packing: what only a Debian package has, or has elsewhere.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(usr ${CPACK_TEMPORARY_DIRECTORY}/usr)
set(changelog ${usr}/share/doc/rind/changelog.Debian)
file(WRITE ${changelog}
"rind (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Built by tools/package/build from rind's sources. What changed for users
    is in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
execute_process(COMMAND gzip -9nf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${usr}/share/doc/rind/CHANGELOG.md ${usr}/share/doc/rind/changelog)
execute_process(COMMAND gzip -9nf ${usr}/share/doc/rind/changelog COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${usr}/share/doc/rind/LICENSE ${usr}/share/doc/rind/copyright)
# As dh_strip does: the compiler's name, which nobody needs.
execute_process(COMMAND strip --remove-section=.comment --remove-section=.note ${usr}/bin/rind
  COMMAND_ERROR_IS_FATAL ANY)
# Debian's zsh looks here.
file(RENAME ${usr}/share/zsh/site-functions ${usr}/share/zsh/vendor-completions)

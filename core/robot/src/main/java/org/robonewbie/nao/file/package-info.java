/**
 * Safe access to files: atomic writes ({@link org.robonewbie.nao.file.AtomicFile}), reading of untrusted files ({@link
 * org.robonewbie.nao.file.TextFile}, {@link org.robonewbie.nao.file.RegularFile}, {@link
 * org.robonewbie.nao.file.SubmittedFolder}), temporary files ({@link org.robonewbie.nao.file.TemporaryFiles}), and the encoding of
 * file names ({@link org.robonewbie.nao.file.PathEncoding}).
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.file;

/**
 * Files that are written as a whole ({@link org.robonewbie.nao.file.AtomicFile}), files of which nothing is known yet
 * ({@link org.robonewbie.nao.file.TextFile}, {@link org.robonewbie.nao.file.RegularFile}, {@link
 * org.robonewbie.nao.file.SubmittedFolder}), temporary ones ({@link org.robonewbie.nao.file.TemporaryFiles}), and names that
 * could not be decoded ({@link org.robonewbie.nao.file.PathEncoding}).
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.file;

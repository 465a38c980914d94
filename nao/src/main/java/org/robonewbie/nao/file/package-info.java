/**
 * Files that are written as a whole ({@link org.robonewbie.nao.file.AtomicFile}), and files of which nothing is known yet
 * ({@link org.robonewbie.nao.file.TextFile}, {@link org.robonewbie.nao.file.RegularFile}, {@link
 * org.robonewbie.nao.file.SubmittedFolder}).
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.file;

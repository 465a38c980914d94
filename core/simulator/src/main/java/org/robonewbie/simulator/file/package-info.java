/**
 * Recordings and reports as files. Read {@link org.robonewbie.simulator.file.RecordingFile} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.file;

/**
 * Recordings and reports as files. Read {@link org.robonewbie.simulator.file.RecordingFile} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.file;

/**
 * Data sets of many runs, recorded on all processors. Read {@link org.robonewbie.app.recording.ParallelRecording} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.recording;

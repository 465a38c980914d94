/**
 * What remains of a run: the recording, from which it can be shown again, and the report with its true results. Read {@link
 * org.robonewbie.simulator.recording.RunRecorder} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.recording;

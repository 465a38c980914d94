/**
 * The output of a run: a recording for replay and a report with the ground-truth results. Read {@link
 * org.robonewbie.simulator.recording.RunRecorder} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.recording;

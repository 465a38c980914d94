/**
 * The output for monitors: SimSpark's scene graph, the monitor port with its trainer commands, and logs for RoboViz. Read {@link
 * org.robonewbie.simulator.monitor.MonitorPort} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.monitor;

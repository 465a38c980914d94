/**
 * What the simulator shows to monitors: the scene as SimSpark builds it, the monitor port with its trainer commands, and logs
 * for RoboViz. Read {@link org.robonewbie.simulator.monitor.MonitorPort} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.monitor;

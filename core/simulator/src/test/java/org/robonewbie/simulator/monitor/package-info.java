/** Tests of what monitors are shown and may ask for. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.monitor;

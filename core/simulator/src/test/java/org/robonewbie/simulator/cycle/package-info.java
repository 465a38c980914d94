/** Tests of the beat of the world. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.cycle;

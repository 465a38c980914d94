/** Tests of the game's rules, in the real world of the simulator. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.soccer;

/** Tests of the simulator inside an agent's process. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.embedded;

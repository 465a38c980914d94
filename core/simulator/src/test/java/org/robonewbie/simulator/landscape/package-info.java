/** Tests of what stands on the pitch. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.landscape;

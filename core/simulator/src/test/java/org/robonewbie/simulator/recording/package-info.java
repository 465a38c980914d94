/** Tests of recordings and reports. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.recording;

/** Tests of recordings and reports as files. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.file;

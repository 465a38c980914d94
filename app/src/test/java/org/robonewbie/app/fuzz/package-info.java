/** Readers under bytes that nobody would send. Read {@link org.robonewbie.app.fuzz.FuzzedReader}. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.fuzz;

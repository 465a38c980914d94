/** Tests of how programs of students are found, compiled and run. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs;

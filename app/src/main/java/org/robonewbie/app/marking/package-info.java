/**
 * All programs of a class graded into one table, and compared with each other. Read {@link org.robonewbie.app.marking.ClassMarking}
 * first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.marking;

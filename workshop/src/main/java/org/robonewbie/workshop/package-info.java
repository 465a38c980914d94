/**
 * The maintainers' measurements. Read {@link org.robonewbie.workshop.Bench} first, the command line.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop;

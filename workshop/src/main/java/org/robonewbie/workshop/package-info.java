/**
 * Measurements for maintainers. Start with the command line, {@link org.robonewbie.workshop.Bench}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop;

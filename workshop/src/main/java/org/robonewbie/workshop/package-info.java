/**
 * Measurements for maintainers. Start with the command line, {@link org.robonewbie.workshop.Bench}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop;

/**
 * Reproducible competitions between programs. Read {@link org.robonewbie.competition.Competition} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition;

/**
 * Matches between the example team and fixed sparring partners, with the statistics by which changes of play are judged. Start
 * with {@link org.robonewbie.workshop.sparring.SparringLeague}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.sparring;

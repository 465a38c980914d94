/**
 * Robots that try motions and walks one after the other, and what comes of it: a walk, a kick, a dive, getting up. Read {@link
 * org.robonewbie.learning.rehearsal.Rehearsal} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.rehearsal;

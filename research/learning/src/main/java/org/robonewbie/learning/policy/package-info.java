/**
 * Learning by trying: an evolution strategy improves the numbers of a policy, lesson by lesson. Read {@link
 * org.robonewbie.learning.policy.PolicyTraining} first, then {@link org.robonewbie.learning.policy.WalkCourse}, what is learned.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.policy;

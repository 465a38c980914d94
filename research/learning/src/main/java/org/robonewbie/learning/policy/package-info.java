/**
 * Direct policy search: an evolution strategy optimises the network of a task by the returns of its episodes. Read {@link
 * org.robonewbie.learning.policy.PolicySearch} first, then {@link org.robonewbie.learning.policy.PolicyModel}, which maps policies to
 * parameter vectors.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.policy;

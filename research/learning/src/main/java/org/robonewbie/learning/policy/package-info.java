/**
 * Search for policies: an evolution strategy improves the network of a task, episode by episode. Read {@link
 * org.robonewbie.learning.policy.PolicySearch} first, then {@link org.robonewbie.learning.policy.PolicyModel}, the numbers that are
 * searched.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.policy;

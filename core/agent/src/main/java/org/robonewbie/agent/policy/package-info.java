/**
 * Learned policies. Read {@link org.robonewbie.agent.policy.Policy} first; {@link org.robonewbie.agent.policy.PolicyText}
 * describes the text format.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.policy;

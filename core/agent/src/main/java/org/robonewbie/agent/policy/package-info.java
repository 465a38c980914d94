/**
 * What robots have learned. Read {@link org.robonewbie.agent.policy.Policy} first; {@link org.robonewbie.agent.policy.PolicyText}
 * says how it is written.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.policy;

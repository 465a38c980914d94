/** Policies in files: {@link org.robonewbie.agent.policy.file.PolicyFile}. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.policy.file;

/** Policy files. Read {@link org.robonewbie.agent.policy.file.PolicyFile} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.policy.file;

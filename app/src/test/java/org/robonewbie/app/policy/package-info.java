/** Policies from other tools. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.policy;

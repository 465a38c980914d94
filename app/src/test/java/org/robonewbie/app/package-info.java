/** Tests of the command line, of the launcher, and of the rules that hold for the whole house. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app;

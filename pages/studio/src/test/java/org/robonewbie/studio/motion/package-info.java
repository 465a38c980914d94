/** Tests of the motion editor's server side. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.motion;

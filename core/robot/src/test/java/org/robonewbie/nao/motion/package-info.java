/** Tests of motions and their files. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.motion;

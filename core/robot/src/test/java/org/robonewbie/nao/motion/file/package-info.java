@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.motion.file;

@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.file;

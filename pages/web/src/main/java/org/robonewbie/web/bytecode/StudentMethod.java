package org.robonewbie.web.bytecode;

import org.robonewbie.web.bytecode.ClassFile.MethodCode;

/**
 * A method of a student's class.
 *
 * @param home the declaring class
 * @param code its bytecode
 */
record StudentMethod(StudentClass home, MethodCode code) {

    Descriptor type() {
        return Descriptor.of(code.descriptor());
    }
}

package org.robonewbie.pagejvm;

import org.robonewbie.pagejvm.ClassFile.MethodCode;

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

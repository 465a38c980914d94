package org.robonewbie.web.compiling;

import java.lang.reflect.Modifier;
import java.util.Set;
import org.teavm.extension.introspect.IntrospectMember;
import org.teavm.extension.spi.reflection.SimpleReflectionPolicy;

/** Keeps in the compiled program, with its name, whatever a student's program may call. */
public final class ProgramsCall extends SimpleReflectionPolicy {

    /** What begins a simulator, which the page carries out in another way, and what makes threads wait for each other. */
    private static final Set<String> OTHERWISE = Set.of(
            "Nao.connect", "Agent.run", "Agent.runTogether", "Object.wait", "Object.notify", "Object.notifyAll");

    /** Creates the policy; TeaVM finds it by its name. */
    public ProgramsCall() {}

    @Override
    protected void setup() {
        selectClasses(type -> ProgramLibrary.has(type.name()))
                .foundByName()
                .reflectableMembers(ProgramsCall::isCallable);
    }

    private static boolean isCallable(IntrospectMember member) {
        return PUBLIC.test(member)
                && !Modifier.isNative(member.modifiers())
                && !OTHERWISE.contains(member.declaringClass().simpleName() + "." + member.name());
    }
}

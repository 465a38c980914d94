package org.robonewbie.web.compiling.javac;

import java.util.Map;
import java.util.Set;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.Program;
import org.teavm.model.ValueType;
import org.teavm.model.instructions.ExitInstruction;
import org.teavm.model.instructions.IntegerConstantInstruction;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.model.instructions.NullConstantInstruction;
import org.teavm.vm.spi.TeaVMHost;
import org.teavm.vm.spi.TeaVMPlugin;

/**
 * TeaVM plug-in that stubs out the parts of javac that need files, plug-ins, annotation processors or the JDK's class loaders. The stubs do
 * nothing and return false or null.
 */
public final class JavacWithoutFiles implements TeaVMPlugin, ClassHolderTransformer {

    private static final String JAVAC = "com.sun.tools.javac.";

    /** Stubbed methods by class. */
    private static final Map<String, Set<String>> LEFT_OUT = Map.of(
            JAVAC + "model.AnnotationProxyMaker", Set.of("generateAnnotation"),
            JAVAC + "api.BasicJavacTask", Set.of("initPlugins", "initDocLint"),
            JAVAC + "main.JavaCompiler", Set.of("initProcessAnnotations"),
            JAVAC + "file.BaseFileManager", Set.of("deferredClose"));

    /** Calls that are removed from the calling methods, by class. */
    private static final Map<String, String> CALLS_LEFT_OUT =
            Map.of(JAVAC + "file.JavacFileManager", "preRegister", "java.lang.System", "exit");

    /** Creates the plug-in; TeaVM finds it by name. */
    public JavacWithoutFiles() {}

    @Override
    public void install(TeaVMHost host) {
        host.add(this);
    }

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (!type.getName().startsWith(JAVAC)) {
            return;
        }
        Set<String> leftOut = LEFT_OUT.getOrDefault(type.getName(), Set.of());
        for (MethodHolder method : type.getMethods()) {
            if (leftOut.contains(method.getName())) {
                method.setProgram(doingNothing(method));
            } else if (method.getProgram() != null) {
                leaveOutCalls(method.getProgram());
            }
        }
        if (type.getName().equals(JAVAC + "comp.Modules")) {
            type.getMethods().stream()
                    .filter(method -> method.getName().equals("filterAlreadyWarnedIncubatorModules"))
                    .forEach(method -> method.setProgram(givingBackItsArgument(method)));
        }
    }

    private static void leaveOutCalls(Program program) {
        for (BasicBlock block : program.getBasicBlocks()) {
            for (Instruction instruction : block) {
                if (instruction instanceof InvokeInstruction call
                        && call.getMethod().getName().equals(CALLS_LEFT_OUT.get(call.getMethod().getClassName()))) {
                    call.delete();
                }
            }
        }
    }

    private static Program doingNothing(MethodHolder method) {
        Program program = withVariables(method);
        BasicBlock block = program.createBasicBlock();
        ExitInstruction exit = new ExitInstruction();
        if (method.getResultType() == ValueType.BOOLEAN) {
            IntegerConstantInstruction zero = new IntegerConstantInstruction();
            zero.setReceiver(program.createVariable());
            block.add(zero);
            exit.setValueToReturn(zero.getReceiver());
        } else if (method.getResultType() != ValueType.VOID) {
            NullConstantInstruction nothing = new NullConstantInstruction();
            nothing.setReceiver(program.createVariable());
            block.add(nothing);
            exit.setValueToReturn(nothing.getReceiver());
        }
        block.add(exit);
        return program;
    }

    private static Program givingBackItsArgument(MethodHolder method) {
        Program program = withVariables(method);
        ExitInstruction exit = new ExitInstruction();
        exit.setValueToReturn(program.variableAt(1));
        program.createBasicBlock().add(exit);
        return program;
    }

    /** TeaVM numbers {@code this} first, even in a static method, and then the arguments. */
    private static Program withVariables(MethodHolder method) {
        Program program = new Program();
        for (int i = 0; i <= method.parameterCount(); i++) {
            program.createVariable();
        }
        return program;
    }
}

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.teavm.diagnostics.DefaultProblemTextConsumer;
import org.teavm.diagnostics.Problem;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.ClassReader;
import org.teavm.model.Instruction;
import org.teavm.model.InvokeDynamicInstruction;
import org.teavm.model.MethodDescriptor;
import org.teavm.model.MethodHandle;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.RuntimeConstant;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.tooling.ConsoleTeaVMToolLog;
import org.teavm.tooling.TeaVMTargetType;
import org.teavm.tooling.TeaVMTool;
import org.teavm.tooling.TeaVMToolException;
import org.teavm.vm.TeaVMOptimizationLevel;

/**
 * Compiles a program and its dependencies to one WebAssembly file, and puts TeaVM's loader next to it.
 *
 * <p>Usage: {@code java -cp CLASS_PATH CompileToWebAssembly.java MAIN_CLASS FILE}
 */
final class CompileToWebAssembly {

    private static final String LOADER = "org/teavm/backend/wasm/wasm-gc-module-runtime.min.js";

    private CompileToWebAssembly() {}

    public static void main(String[] args) throws IOException, TeaVMToolException {
        Path file = Path.of(args[1]);
        Files.createDirectories(file.getParent());
        TeaVMTool compiler = compiler(args[0], file);
        compiler.generate();
        List<Problem> problems = compiler.getProblemProvider().getProblems();
        problems.forEach(CompileToWebAssembly::print);
        if (!compiler.getProblemProvider().getSevereProblems().isEmpty()) {
            System.exit(1);
        }
        try (InputStream loader = CompileToWebAssembly.class.getClassLoader().getResourceAsStream(LOADER)) {
            Files.copy(loader, file.resolveSibling("webassembly-loader.js"), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static TeaVMTool compiler(String mainClass, Path file) throws MalformedURLException {
        TeaVMTool compiler = new TeaVMTool();
        compiler.setLog(new ConsoleTeaVMToolLog(false));
        compiler.setTargetType(TeaVMTargetType.WEBASSEMBLY_GC);
        compiler.setMainClass(mainClass);
        compiler.setTargetDirectory(file.getParent().toFile());
        compiler.setTargetFileName(file.getFileName().toString());
        compiler.setOptimizationLevel(TeaVMOptimizationLevel.ADVANCED);
        compiler.setObfuscated(true);
        compiler.setStrict(true);
        List<File> classPath = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(File::new)
                .toList();
        compiler.setClassPath(classPath);
        compiler.setClassLoader(CompileToWebAssembly.class.getClassLoader());
        compiler.getTransformers().add(PortableCalls.class.getName());
        return compiler;
    }

    private static void print(Problem problem) {
        DefaultProblemTextConsumer text = new DefaultProblemTextConsumer();
        problem.render(text);
        String place = problem.getLocation() == null ? "" : " (" + problem.getLocation().getMethod() + " "
                + problem.getLocation().getSourceLocation() + ")";
        System.err.println(problem.getSeverity() + ": " + text.getText() + place);
    }

    /**
     * Redirects calls of {@code Math} and {@code StrictMath} to the methods of {@code PortableMath} that have the same name. TeaVM's own differ
     * from the JVM's in the last bit, which changes the recording of a run.
     */
    public static final class PortableCalls implements ClassHolderTransformer {

        private static final String PORTABLE = "org.robonewbie.nao.math.PortableMath";
        private static final Set<String> REPLACED = Set.of("java.lang.Math", "java.lang.StrictMath");

        /** Creates the transformer; TeaVM finds it by name. */
        public PortableCalls() {}

        @Override
        public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
            ClassReader portable = context.getHierarchy().getClassSource().get(PORTABLE);
            if (portable == null) {
                return; // the program is the Java compiler
            }
            for (MethodHolder method : type.getMethods()) {
                if (method.getProgram() != null) {
                    for (BasicBlock block : method.getProgram().getBasicBlocks()) {
                        block.forEach(instruction -> redirect(instruction, portable));
                    }
                }
            }
        }

        private static void redirect(Instruction instruction, ClassReader portable) {
            if (instruction instanceof InvokeInstruction call) {
                MethodReference called = call.getMethod();
                if (isRedirected(called.getClassName(), called.getDescriptor(), portable)) {
                    call.setMethod(new MethodReference(PORTABLE, called.getDescriptor()));
                }
            } else if (instruction instanceof InvokeDynamicInstruction lambda) {
                lambda.getBootstrapArguments().replaceAll(argument -> redirected(argument, portable));
            }
        }

        /** Redirects a method reference such as {@code Math::sin}. */
        private static RuntimeConstant redirected(RuntimeConstant argument, ClassReader portable) {
            if (argument.getKind() != RuntimeConstant.METHOD_HANDLE) {
                return argument;
            }
            MethodHandle handle = argument.getMethodHandle();
            MethodDescriptor descriptor = new MethodDescriptor(handle.getName(), handle.signature());
            return isRedirected(handle.getClassName(), descriptor, portable)
                    ? new RuntimeConstant(MethodHandle.staticCaller(PORTABLE, descriptor))
                    : argument;
        }

        private static boolean isRedirected(String owner, MethodDescriptor method, ClassReader portable) {
            return REPLACED.contains(owner) && portable.getMethod(method) != null;
        }
    }
}

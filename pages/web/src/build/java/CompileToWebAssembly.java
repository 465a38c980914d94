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
import org.teavm.diagnostics.DefaultProblemTextConsumer;
import org.teavm.diagnostics.Problem;
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
        return compiler;
    }

    private static void print(Problem problem) {
        DefaultProblemTextConsumer text = new DefaultProblemTextConsumer();
        problem.render(text);
        String place = problem.getLocation() == null ? "" : " (" + problem.getLocation().getMethod() + " "
                + problem.getLocation().getSourceLocation() + ")";
        System.err.println(problem.getSeverity() + ": " + text.getText() + place);
    }
}

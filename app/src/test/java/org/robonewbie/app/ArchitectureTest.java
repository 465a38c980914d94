package org.robonewbie.app;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.ThreadLocalRandom;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Keeps the arrows between the modules, so that the code can be read part by part. */
class ArchitectureTest {

    private static final JavaClasses HOUSE = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .withImportOption(location -> !location.contains("-tests.jar"))
            .importPackages("org.robonewbie");

    /** The modules that must run where there is nothing but Java's basic classes, such as in a page of the browser. */
    private static final String[] CORE = {
        "org.robonewbie.nao..",
        "org.robonewbie.robot..",
        "org.robonewbie.protocol..",
        "org.robonewbie.agent..",
        "org.robonewbie.simulator..",
        "org.robonewbie.trial.."
    };

    private static final DescribedPredicate<JavaClass> OUTSIDE = resideInAnyPackage(
                    "java.net..",
                    "java.nio.file..",
                    "java.nio.channels..",
                    "java.util.concurrent",
                    "java.util.concurrent.locks",
                    "java.lang.management")
            .or(assignableTo(Thread.class))
            .or(assignableTo(ServiceLoader.class))
            .or(nameMatching("java\\.io\\.(File|RandomAccessFile).*"))
            .as("classes for threads, sockets, clocks and files");

    /** Functions of {@link Math} that are exact, and so the same in every JVM and browser. */
    private static final Set<String> EXACT = Set.of(
            "abs",
            "addExact",
            "ceil",
            "copySign",
            "floor",
            "floorDiv",
            "floorMod",
            "max",
            "min",
            "multiplyExact",
            "signum",
            "sqrt",
            "subtractExact",
            "toIntExact");

    /** Each module, and what it may use beside Java itself and its own classes. */
    static Stream<Arguments> modules() {
        return Stream.of(
                Arguments.of("nao", new String[] {}),
                Arguments.of("robot", new String[] {"org.robonewbie.nao.."}),
                Arguments.of("protocol", new String[] {"org.robonewbie.nao..", "org.robonewbie.robot.."}),
                Arguments.of(
                        "agent",
                        new String[] {"org.robonewbie.nao..", "org.robonewbie.robot..", "org.robonewbie.protocol.."}),
                Arguments.of("simulator", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol..",
                    "org.ode4j..",
                    "com.google.gson..",
                    "org.slf4j.."
                }),
                Arguments.of("trial", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.agent..",
                    "org.robonewbie.simulator.."
                }),
                Arguments.of("programs", new String[] {
                    "org.robonewbie.trial..",
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.agent..",
                    "com.sun.source..",
                    "javax.lang.model..",
                    "javax.tools.."
                }),
                Arguments.of("studio", new String[] {
                    "org.robonewbie.trial..",
                    "org.robonewbie.programs..",
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.simulator..",
                    "org.eclipse.jetty..",
                    "com.google.gson..",
                    "org.slf4j.."
                }),
                Arguments.of("learning", new String[] {
                    "org.robonewbie.trial..",
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.agent..",
                    "org.robonewbie.simulator..",
                    "com.google.gson.."
                }),
                Arguments.of("competition", new String[] {
                    "org.robonewbie.trial..",
                    "org.robonewbie.programs..",
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol.effector..",
                    "org.robonewbie.protocol.frame..",
                    "org.robonewbie.protocol.order..",
                    "org.robonewbie.simulator..",
                    "com.google.gson.."
                }),
                Arguments.of("exercises", new String[] {
                    "org.robonewbie.programs..",
                    "org.robonewbie.nao..",
                    "org.robonewbie.robot..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.agent..",
                    "org.robonewbie.simulator..",
                    "org.robonewbie.trial..",
                    "com.google.gson..",
                    "javax.crypto..",
                    "javax.lang.model.."
                }),
                Arguments.of(
                        "examples",
                        new String[] {"org.robonewbie.nao..", "org.robonewbie.robot..", "org.robonewbie.agent.."}),
                Arguments.of(
                        "team",
                        new String[] {"org.robonewbie.nao..", "org.robonewbie.robot..", "org.robonewbie.agent.."}));
    }

    @ParameterizedTest
    @MethodSource("modules")
    void moduleUsesNothingButWhatItMay(String module, String... allowed) {
        String own = "org.robonewbie." + module + "..";
        String[] all = Stream.concat(Stream.of(own, "java..", "org.jspecify.."), Stream.of(allowed))
                .toArray(String[]::new);

        classes()
                .that()
                .resideInAPackage(own)
                .should()
                .onlyDependOnClassesThat(resideInAnyPackage(all))
                .check(HOUSE);
    }

    @Test
    void physicsEngineIsKnownInOnePackageOnly() {
        noClasses()
                .that(not(resideInAnyPackage("org.robonewbie.simulator.physics.ode..")))
                .should()
                .dependOnClassesThat()
                .resideInAPackage("org.ode4j..")
                .check(HOUSE);
    }

    @Test
    void onlyTheCommandLineKnowsItsLibrary() {
        noClasses()
                .that(not(resideInAnyPackage("org.robonewbie.app..")))
                .should()
                .dependOnClassesThat()
                .resideInAPackage("picocli..")
                .check(HOUSE);
    }

    @Test
    void modulesAndPackagesHaveNoCycles() {
        slices().matching("org.robonewbie.(*)..").should().beFreeOfCycles().check(HOUSE);
        slices().matching("org.robonewbie.(**)").should().beFreeOfCycles().check(HOUSE);
    }

    @Test
    void pictureOfTheModulesShowsThemAsTheyAre() throws IOException {
        Path picture = Project.ROOT.resolve("docs/images/modules.svg");
        Path asItIs = Files.writeString(Path.of("target", "modules.svg"), new ModulePicture(HOUSE).svg());

        assertThat(picture)
                .as("The arrows have changed. Do they still point down only? Then: cp app/target/modules.svg"
                        + " docs/images")
                .hasSameTextualContentAs(asItIs);
    }

    @Test
    void worldKnowsNeitherClockNorChance() {
        noClasses()
                .that()
                .resideInAnyPackage(
                        "org.robonewbie.nao..",
                        "org.robonewbie.robot..",
                        "org.robonewbie.simulator.physics..",
                        "org.robonewbie.simulator.world..",
                        "org.robonewbie.simulator.sensing..",
                        "org.robonewbie.simulator.soccer..")
                .should()
                .callMethod(System.class, "nanoTime")
                .orShould()
                .callMethod(System.class, "currentTimeMillis")
                .orShould()
                .callMethod(Math.class, "random")
                .orShould()
                .callConstructor(Random.class)
                .orShould()
                .dependOnClassesThat()
                .areAssignableTo(ThreadLocalRandom.class)
                .orShould()
                .dependOnClassesThat()
                .haveFullyQualifiedName("java.time.Instant")
                .check(HOUSE);
    }

    /** The edge packages as the table in CONTRIBUTING.md names them; all other packages of these modules are the core. */
    private static String[] edges() {
        return Pattern.compile("\\| `([a-z.]+)` \\| edge:")
                .matcher(Project.read(Project.ROOT.resolve("CONTRIBUTING.md")))
                .results()
                .map(row -> "org.robonewbie." + row.group(1))
                .toArray(String[]::new);
    }

    @Test
    void coreNeedsNeitherThreadNorSocketNorClockNorEnvironmentNorFile() {
        noClasses()
                .that(resideInAnyPackage(CORE))
                .and(not(resideInAnyPackage(edges())))
                .should()
                .dependOnClassesThat(OUTSIDE)
                .orShould()
                .callMethod(System.class, "nanoTime")
                .orShould()
                .callMethod(System.class, "currentTimeMillis")
                .orShould()
                .callMethod(System.class, "getenv")
                .orShould()
                .callMethod(System.class, "getenv", String.class)
                .orShould()
                .callMethod(Object.class, "wait")
                .check(HOUSE);
    }

    @Test
    void eachEdgeNeedsSomethingFromOutside() {
        assertThat(edges())
                .hasSizeGreaterThan(5)
                .allSatisfy(edge -> assertThat(HOUSE)
                        .filteredOn(type -> type.getPackageName().equals(edge))
                        .as("classes of the edge package " + edge)
                        .anyMatch(type -> type.getDirectDependenciesFromSelf().stream()
                                .anyMatch(dependency -> OUTSIDE.test(dependency.getTargetClass()))));
    }

    @Test
    void worldMovesByPortableMathematics() {
        noClasses()
                .that()
                .resideInAnyPackage(CORE)
                .should()
                .accessTargetWhere(describe(
                        "it is a function of Math whose last bit the platform decides",
                        access -> (access.getTargetOwner().isAssignableTo(Math.class)
                                        && !EXACT.contains(access.getName()))
                                || access.getTargetOwner().isAssignableTo(StrictMath.class)))
                .check(HOUSE);
    }

    @Test
    void nobodyOpensWindowsOfTheOperatingSystem() {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.awt..", "javax.swing..")
                .check(HOUSE);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"nao", "protocol", "agent", "simulator", "trial", "programs", "studio", "examples", "team", "app"
            })
    void moduleIsLookedAt(String module) {
        assertThat(HOUSE).anyMatch(type -> type.getPackageName().startsWith("org.robonewbie." + module));
    }
}

package org.robonewbie.app;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Random;
import java.util.concurrent.ThreadLocalRandom;
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
            .importPackages("org.robonewbie");

    /** Each module, and what it may use beside Java itself and its own classes. */
    static Stream<Arguments> modules() {
        return Stream.of(
                Arguments.of("nao", new String[] {}),
                Arguments.of("protocol", new String[] {"org.robonewbie.nao.."}),
                Arguments.of("agent", new String[] {"org.robonewbie.nao..", "org.robonewbie.protocol.."}),
                Arguments.of("simulator", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.protocol..",
                    "org.ode4j..",
                    "com.sun.management..",
                    "com.google.gson..",
                    "org.slf4j.."
                }),
                Arguments.of("studio", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.simulator..",
                    "org.eclipse.jetty..",
                    "com.google.gson..",
                    "org.slf4j.."
                }),
                Arguments.of("learning", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.agent..",
                    "org.robonewbie.simulator..",
                    "com.google.gson.."
                }),
                Arguments.of("competition", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.protocol.frame..",
                    "org.robonewbie.simulator..",
                    "com.google.gson..",
                    "javax.tools.."
                }),
                Arguments.of("exercises", new String[] {
                    "org.robonewbie.nao..",
                    "org.robonewbie.protocol..",
                    "org.robonewbie.agent..",
                    "org.robonewbie.simulator..",
                    "com.google.gson.."
                }),
                Arguments.of("examples", new String[] {
                    "org.robonewbie.nao..", "org.robonewbie.agent..", "org.robonewbie.protocol.perceptor.."
                }));
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
    void modulesHaveNoCycles() {
        slices().matching("org.robonewbie.(*)..").should().beFreeOfCycles().check(HOUSE);
    }

    @Test
    void worldKnowsNeitherClockNorChance() {
        noClasses()
                .that()
                .resideInAnyPackage(
                        "org.robonewbie.nao..",
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

    @Test
    void nobodyOpensWindowsOfTheOperatingSystem() {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.awt..", "javax.swing..")
                .check(HOUSE);
    }

    @ParameterizedTest
    @ValueSource(strings = {"nao", "protocol", "agent", "simulator", "studio", "examples", "app"})
    void moduleIsLookedAt(String module) {
        assertThat(HOUSE).anyMatch(type -> type.getPackageName().startsWith("org.robonewbie." + module));
    }
}

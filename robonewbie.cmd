@echo off
rem Runs RoboNewbie; app\src\launcher\java\Build.java builds it first if necessary. Linux and macOS use the script "robonewbie".
setlocal DisableDelayedExpansion
set "JAR="
set "JAVA=java"
if exist "%JAVA_HOME%\bin\java.exe" set "JAVA=%JAVA_HOME%\bin\java.exe"
if exist "%~dp0runtime\bin\java.exe" set "JAVA=%~dp0runtime\bin\java.exe"
rem Java 17 is the first version with this option.
"%JAVA%" --enable-native-access=ALL-UNNAMED -version >nul 2>&1
if errorlevel 1 goto no_java
set "RELEASE=%~dp0maven\org\robonewbie\robonewbie"
pushd "%RELEASE%" 2>nul
if errorlevel 1 goto build
for /d %%v in (*) do set "JAR=%RELEASE%\%%v\robonewbie-%%v.jar"
popd
if not defined JAR goto build
set "SHARE=-Xshare:auto"
if exist "%JAR%.jsa" set "SHARE=-XX:SharedArchiveFile=%JAR%.jsa"
"%JAVA%" -XX:+UseSerialGC -XX:+DisableAttachMechanism "%SHARE%" -Xlog:disable "-Drobonewbie.home=%~dp0." "-Drobonewbie.terminal=true" "-Drobonewbie.archive=%JAR%.jsa" -jar "%JAR%" %*
exit /b %ERRORLEVEL%

:build
"%JAVA%" "%~dp0app\src\launcher\java\Build.java" "%~dp0." start %*
exit /b %ERRORLEVEL%

:no_java
>&2 echo robonewbie: a JDK 17 or newer is needed. "%JAVA%" is not one.
>&2 echo   Install a JDK, for example Temurin from https://adoptium.net (any version from 17 on),
>&2 echo   open a new window and try again. If it is installed already, set JAVA_HOME to its folder.
exit /b 1

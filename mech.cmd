@echo off
rem mech - starts MechService's command line on Windows: what `mech` does elsewhere, without its build
rem and without its archive of classes. In a release archive, as bin\mech.cmd, it starts ..\lib.
setlocal
set "home=%~dp0"
if exist "%home%..\lib\mechcli.jar" (
  set "classes=%home%..\lib\mechcli.jar;%home%..\lib\*"
) else (
  set "classes=%home%mechcli\target\mechcli.jar;%home%mechcli\target\lib\*"
  if not exist "%home%mechcli\target\mechcli.jar" (
    echo S-049 mech has to be built first: mvn -q -pl mechcli -am package -DskipTests 1>&2
    exit /b 2
  )
)
set "java=java"
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java"
"%java%" -version >nul 2>&1
if errorlevel 1 (
  echo S-049 mech needs Java 17 or newer, and there is no java. Install one or set JAVA_HOME. 1>&2
  exit /b 2
)
"%java%" -Xlog:disable -XX:+UseSerialGC -cp "%classes%" org.mechservice.cli.Mech %*
exit /b %errorlevel%
